# tests of several conditions on one element, of itself, and of the link to the state above
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {a (state <s> ^superstate { <> nil <ss> }) (<ss> ^box <b>) (<b> ^color red ^size { > 3 <n> }) --> (<s> ^a <n>)}
sp {b (state <s> ^superstate <ss>) (<ss> ^box <b>) (<b> ^color red ^size { <n> < 9 <> 8 }) --> (<s> ^b <n>)}
sp {c (state <s> ^superstate <ss>) (<ss> ^box <b>) (<b> ^color red ^size { >= <n> <n> << 7 2 >> }) --> (<s> ^c <n>)}
sp {fin (state <s> ^a <a> ^b { <b> <= <a> << 7 9 >> } ^c <c> ^superstate { <t> <> nil }) --> (<t> ^done <a> <b> <c>)}
watch 0
trace --learning 2
chunk always
run 4
chunk stats
