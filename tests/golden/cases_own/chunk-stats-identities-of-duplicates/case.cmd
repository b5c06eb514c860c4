# identities of a learned rule's instance are counted before the rule turns out to be known
chunk always
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 3 ^flag red ^size 1 ^multi 1 ^multi 2 ^multi 3 ^box <b0> ^box <b1> ^spot <b0>) (<b0> ^size 6 ^w 5 ^kind red ^next <b1>) (<b1> ^size 8 ^w 6 ^kind blue ^next <b0>)}
sp {lprop0b (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^flag <v0>) --> (<s> ^operator <o> + =) (<o> ^name lo0b ^val <v0>)}
sp {deep20 (state <s> ^superstate <sx> ^impasse no-change) (<sx> ^operator <lo> ^superstate <ss>) (<lo> ^name <lon> ^val <lv>) (<ss> ^box <db>) (<db> ^size <dv>) --> (<s> ^d20 <dv>)}
sp {dres2 (state <s> ^d20 <dv> ^superstate <sx>) (<sx> ^superstate <ss>) (<sx> ^operator.val <zz>) --> (<sx> ^l25 <dv>)}
run 9
chunk stats
