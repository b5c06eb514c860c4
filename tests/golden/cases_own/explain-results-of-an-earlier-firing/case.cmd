# a firing whose object became a result later has made it
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 4 ^flag green ^size 5 ^multi 1 ^multi 2 ^multi 3 ^box <b0>) (<b0> ^size 2 ^w 3 ^kind green ^next <b0>) (<b0> ^w 2)}
sp {prop0 (state <s> ^superstate nil ^ph 0) --> (<s> ^operator <o> +) (<o> ^name go0)}
sp {loc00 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go0) (<ss> ^box <x0>) (<x0> ^w <v0>) --> (<s> ^l01 <st>) (<st> ^v <v0> ^k <v0>)}
sp {res00 (state <s> ^superstate <ss>)  (<s> ^l01 <x0>) (<x0> ^v <v0>) --> (<ss> ^done0 2)}
sp {res02 (state <s> ^l01 <st> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go0) (<ss> ^box <x0>) (<x0> ^size <v0>) (<s> -^nothere) --> (<ss> ^res02 <st>)}
run 5
explain chunk 2
explain formation
