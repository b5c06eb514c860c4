# a rule that tests an item of a tie uses what the proposal rests on
decide indifferent-selection -f
wm activation --set activation on
sp {s (state <s> ^superstate nil -^round) --> (<s> ^operator <o> + >) (<o> ^name start)}
sp {sa (state <s> ^operator.name start) --> (<s> ^round 1)}
sp {pb (state <s> ^superstate nil ^round <r>) --> (<s> ^operator <o> +) (<o> ^name b)}
sp {pc (state <s> ^superstate nil ^round <r>) --> (<s> ^operator <o> +) (<o> ^name c)}
sp {res (state <s> ^impasse tie ^item <i>) (<i> ^name b) --> (<s> ^loc <i>)}
run 2
print -i s1
run 1
print -i s1
run 1
print -i s1
