# a comparison passes through a justification of a state that does not learn
sp {init (state <s> ^superstate nil) --> (<s> ^box <b>) (<b> ^size 7 ^w 3)}
sp {prop (state <s> ^superstate nil -^done) --> (<s> ^operator.name go)}
sp {propsub (state <s> ^superstate <ss>) (<ss> ^operator.name go) --> (<s> ^operator.name sub)}
sp {dont (state <s> ^superstate.operator.name sub) --> (dont-learn <s>)}
sp {deep (state <s> ^superstate <ss>) (<ss> ^operator.name sub ^superstate <top>) (<top> ^box <b>) (<b> ^size { <n> > 2 } ^w { <w> < <n> << 3 4 >> }) --> (<ss> ^mid <n> ^w <w>)}
sp {up (state <s> ^superstate <ss> ^mid <n> ^w <w>) --> (<ss> ^done <n> ^ww <w>)}
watch 0
trace --learning 1
chunk except
run 5
print --chunks --full
