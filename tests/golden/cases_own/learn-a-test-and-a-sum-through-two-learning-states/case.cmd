# a comparison and a sum pass through two states that learn
sp {init (state <s> ^superstate nil) --> (<s> ^box <b>) (<b> ^size 7 ^w 3)}
sp {prop (state <s> ^superstate nil -^done) --> (<s> ^operator.name go)}
sp {propsub (state <s> ^superstate <ss>) (<ss> ^operator.name go) --> (<s> ^operator.name sub)}
sp {deep (state <s> ^superstate <ss>) (<ss> ^operator.name sub ^superstate <top>) (<top> ^box <b>) (<b> ^size <n> ^w { <w> < <n> }) --> (<ss> ^mid (+ <n> 1) ^w <w>)}
sp {up (state <s> ^superstate <ss> ^mid <n> ^w <w>) --> (<ss> ^done <n> ^ww <w>)}
watch 0
trace --learning 1
chunk always
run 5
print --chunks --full
