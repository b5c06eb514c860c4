# a forbidden local negation is told with the condition, in a lone negation and in a conjunction
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {lo (state <s> ^superstate <ss> -^absent <v>) (<ss> ^level <l>) --> (<s> ^l <l>)}
sp {fin (state <s> ^l <l> ^superstate <ss>) --> (<ss> ^done <l>)}
sp {fin2 (state <s> ^superstate <ss>) (<ss> ^level <l>) -{(<s> ^gone <x>) (<x> ^at <l>)} --> (<ss> ^done2 <l>)}
watch 1
trace --learning 2
trace --chunk-warnings
chunk always
chunk allow-local-negations off
run 4
chunk stats
print --chunks --full
