# a negated condition counts as local if no positive condition names its object; inside a conjunction objects lead on
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {lo (state <s> ^superstate <ss>) (<ss> ^box <b> ^operator.name go) (<b> ^color red) --> (<s> ^b <b>)}
sp {fin (state <s> ^b <b> ^superstate <ss>) -{(<b> ^next <n>) (<n> ^size > 5)} (<b> -^next.mark) --> (<b> ^done yes)}
watch 0
trace --learning 2
chunk always
run 4
chunk stats
