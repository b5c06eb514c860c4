# a generated agent: chunk stats local negations of duplicates
watch 0
chunk always
explain all on
chunk max-chunks 3
decide indifferent-selection --first
soar max-elaborations 30
trace --learning 1
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 4 ^flag blue ^size 3 ^multi 1 ^multi 2 ^multi 3 ^box <b0> ^box <b1> ^box <b2> ^spot <b0>) (<b0> ^size 3 ^w 2 ^kind blue ^next <b0>) (<b1> ^size 5 ^w 1 ^kind green ^next <b1>) (<b2> ^size 2 ^w 1 ^kind blue ^next <b0>)}
sp {prop0a (state <s> ^superstate nil ^ph 0) --> (<s> ^operator <o> +) (<o> ^name go0 ^which a)}
sp {prop0b (state <s> ^superstate nil ^ph 0 ^spot <b>) --> (<s> ^operator <o> +) (<o> ^name go0 ^which b ^box <b>)}
sp {prop0c (state <s> ^superstate nil ^ph 0) --> (<s> ^operator <o> +) (<o> ^name go0 ^which c)}
sp {adv0 (state <s> ^superstate nil ^done0 ^ph 0 ^operator.name go0) --> (<s> ^ph 0 - ^ph 1)}
sp {loc00 (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<ss> ^flag <v0>) --> (<s> ^l01 <st>) (<st> ^v <v0> ^k 1)}
sp {loc01 (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<s> ^l01 <x0>) (<x0> ^v <v0>) --> (<s> ^l02 3)}
sp {loc02 (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<s> ^l01 <x0>) (<x0> ^v <v0>) (<s> ^l01 <x1>) (<x1> ^v { <v1> <= <v0> }) (<s> ^l01 <x2>) (<x2> ^v <v2>) --> (<s> ^l03 <st>) (<st> ^v <v1> ^k <v1>)}
sp {lprop0a (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<s> ^l03 <x0>) (<x0> ^v <v0>) --> (<s> ^operator <o> + =) (<o> ^name lo0a ^val <v0>)}
sp {lapp0 (state <s> ^operator <o> ^superstate <ss> ) (<o> ^name <n> ^val <v>) (<ss> ^ph 0) (<ss> ^superstate nil) --> (<s> ^l04 <v>)}
sp {deep00 (state <s> ^superstate <sx> ^impasse no-change) (<sx> ^operator <lo> ^superstate <ss>) (<lo> ^name <lon> ^val <lv>) (<sx> ^l01 <dv>) --> (<s> ^d00 <dv>)}
sp {dres0 (state <s> ^d00 <dv> ^superstate <sx>) (<sx> ^superstate <ss>)  --> (<ss> ^done0 <dv>)}
sp {res00 (state <s> ^item <it> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<s> ^l04 <v0>) (<ss> ^size { << 0 1 2 3 4 5 6 7 8 9 10 >> <v1> }) (<s> ^l01 <x2>) (<x2> ^v <v2>) (<ss> -^absent 88) --> (<ss> ^operator <it> >)}
sp {res01 (state <s> ^item <it> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) (<ss> ^num <v0>) (<ss> ^flag <v1>) --> (<ss> ^operator <it> = 2)}
sp {prop1a (state <s> ^superstate nil ^ph 1 ^box <b>) --> (<s> ^operator <o> +) (<o> ^name go1 ^which a ^box <b>)}
sp {prop1b (state <s> ^superstate nil ^ph 1 ^spot <b>) --> (<s> ^operator <o> +) (<o> ^name go1 ^which b ^box <b>)}
sp {adv1 (state <s> ^superstate nil ^done1 ^ph 1 ^operator.name go1) --> (<s> ^ph 1 - ^ph 2)}
sp {loc10 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<ss> ^box <v0>) (<ss> ^box <x1>) (<x1> ^next <v1>) (<s> -^nothere) --> (<s> ^l11 2)}
sp {loc11 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^item <v0>) (<ss> ^num { <v1> <=> 3 }) --> (<s> ^l12 3 ^l13 (abs <v1>))}
sp {loc12 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^l12 <v0>) (<s> ^l11 { <v1> <> <v0> }) (<s> ^l11 <v2>) --> (<s> ^l14 <st>) (<st> ^v 2 ^k 2)}
sp {loc13 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^l13 <v0>) --> (<s> ^l15 <v0>)}
sp {loc14 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^l13 <v0>) (<ss> ^multi <v0>) (<s> -^nothere) --> (<s> ^l16 <st>) (<st> ^v <v0> ^k <v0>)}
sp {res10 (state <s> ^item <it> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^l12 <v0>) (<ss> ^box <x1>) (<x1> ^w { <v1> <> <v0> }) (<s> ^l15 <v2>) -{(<ss> ^box <nb>) (<nb> ^kind black)} --> (<ss> ^operator <it> =)}
sp {res11 (state <s> ^superstate <ss>)  (<s> ^item <v0>) (<s> ^l11 <v1>) (<ss> ^box <v2>) --> (<ss> ^res11 3 ^extra1 <v2>)}
sp {res12 (state <s> ^superstate <ss> ) (<ss> ^ph 1) (<ss> ^superstate nil) (<s> ^l13 { <v0> <=> 3 }) --> (<ss> ^done1 <r>) (<r> ^v <v0> ^sub <q>) (<q> ^w <v0>)}
sp {prop2 (state <s> ^superstate nil ^ph 2) --> (<s> ^operator <o> +) (<o> ^name go2)}
sp {adv2 (state <s> ^superstate nil ^done2 ^ph 2 ^operator.name go2) --> (<s> ^ph 2 - ^ph 3)}
sp {loc20 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<ss> ^spot <x0>) (<x0> ^w <v0>) (<ss> ^num <v0>) -{(<s> ^nowhere <nb>) (<nb> ^kind black)} --> (<s> ^l21 (+ <v0> <v0>))}
sp {loc21 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<s> ^l21 <v0>) --> (<s> ^l22 <v0>)}
sp {loc22 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<s> ^l21 <v0>) (<s> ^l22 { <v1> > 0 }) (<s> ^l21 { > 0 <> 12 <v2> }) --> (<s> ^l23 3 ^l24 <v0>)}
sp {loc23 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<s> ^l21 <v0>) (<s> ^l24 <v1>) (<ss> ^spot <x2>) (<x2> ^next <v2>) --> (<s> ^l25 <v0>)}
sp {lprop2a (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<ss> ^box <x0>) (<x0> ^next <v0>) (<ss> -^absent 77) --> (<s> ^operator <o> + ) (<o> ^name lo2a ^val <v0>)}
sp {lapp2 (state <s> ^operator <o> ^superstate <ss> ^impasse no-change) (<o> ^name lo2b ^val <v>) (<ss> ^operator.name go2) (<ss> ^superstate nil) --> (<s> ^l26 <v>)}
sp {res20 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<ss> ^flag <v0>) --> (<ss> ^done2 <v0>)}
sp {res21 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go2) (<ss> ^superstate nil) (<ss> ^size <v0>) (<ss> ^box <x1>) (<x1> ^kind { <v1> << red green blue >> }) (<s> -^nothere) --> (<ss> ^res21 3)}
sp {res22 (state <s> ^superstate <ss>)  (<s> ^l24 <v0>) --> (<ss> ^res22 2)}
run 7
chunk stats
print --chunks --full
print --justifications --full
explain list-chunks
explain list-justifications
explain chunk 1
explain formation
explain identity
explain constraints
explain stats
explain instantiation 4
explain wm-trace
explain instantiation 5
explain explanation-trace
explain chunk 2
explain formation
explain identity
explain constraints
explain stats
explain instantiation 12
explain wm-trace
explain instantiation 13
explain explanation-trace
explain chunk 3
explain formation
explain identity
explain constraints
explain stats
explain instantiation 6
explain wm-trace
explain instantiation 7
explain explanation-trace
print -d 3 s1
print -d 2 <s>
preferences s1 operator --names
production firing-counts
explain
