# a comparison of a variable with itself stands before its equality
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 4 ^flag green ^size 9 ^multi 1 ^multi 2 ^multi 3 ^box <b0> ^box <b1>) (<b0> ^size 3 ^w 3 ^kind blue ^next <b1>) (<b1> ^size 4 ^w 4 ^kind red ^next <b1>)}
sp {res02 (state <s> ^impasse no-change) (<ss> ^num <v0>) (<ss> ^num { <v1> <= <v0> }) --> (<ss> ^done0 <r>) }
run 4
explain chunk 1
