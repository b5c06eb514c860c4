# what a justification computes is computed by what is learned from it
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {lo (state <s> ^superstate.superstate nil ^superstate <ss>) --> (<s> ^operator.name deeper ^top <ss>)}
sp {force (state <s> ^superstate.superstate nil) --> (force-learn <s>)}
sp {fin (state <s> ^superstate <ss>) (<ss> ^top <t>) (<t> ^box <b>) (<b> ^size <n> ^w <w>) --> (<t> ^sum (+ <n> <w>))}
watch 0
trace --learning 2
chunk only
run 5
chunk stats
