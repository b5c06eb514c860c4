# a generated agent: explain identities of each substate
watch 0
chunk always
explain all on
chunk automatically-create-singletons off
decide indifferent-selection --last
soar max-elaborations 30
trace --learning 1
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 3 ^flag red ^size 6 ^box <b0> ^box <b1> ^box <b2> ^spot <b0>) (<b0> ^size 5 ^w 1 ^kind blue ^next <b2>) (<b1> ^size 5 ^w 6 ^kind blue ^next <b2>) (<b2> ^size 2 ^w 6 ^kind red ^next <b2>) (<b2> ^w 8)}
sp {adv0 (state <s> ^superstate nil ^done0 ^ph 0 ) --> (<s> ^ph 0 - ^ph 1)}
sp {tag0 (state <s> ^superstate <ss> ) (<ss> ^ph 0) (<ss> ^superstate nil) --> (<s> ^tag p0)}
sp {loc00 (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^flag <v0>) --> (<s> ^l01 blue)}
sp {loc01 (state <s> ^tag p0 ^superstate <ss>)  (<s> ^l01 <v0>) --> (<s> ^l02 <v0>)}
sp {loc02 (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^spot <x0>) (<x0> ^size <v0>) (<s> ^l02 <v1>) (<s> ^l02 <v2>) --> (<s> ^l03 <v0>)}
sp {lprop0a (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^flag { <v0> << red green blue >> }) --> (<s> ^operator <o> + =) (<o> ^name lo0a ^val <v0>)}
sp {lprop0b (state <s> ^tag p0 ^superstate <ss>)  (<s> ^l02 <v0>) --> (<s> ^operator <o> + =) (<o> ^name lo0b ^val <v0>)}
sp {lpref00 (state <s> ^tag p0 ^superstate <ss> ^operator <o> +) (<o> ^name lo0b)  (<s> ^l02 <v0>) --> (<s> ^operator <o> <)}
sp {lpref01 (state <s> ^tag p0 ^superstate <ss> ^operator <o> +) (<o> ^name lo0a)  (<s> ^l02 <v0>) --> (<s> ^operator <o> >)}
sp {lapp0 (state <s> ^operator <o> ^tag p0 ^superstate <ss>) (<o> ^name lo0b ^val <v>)  --> (<s> ^l04 <v>)}
sp {deep00 (state <s> ^superstate <sx> ^impasse no-change) (<sx> ^operator <lo> ^superstate <ss>) (<lo> ^name <lon> ^val <lv>) (<lo> ^val <dv>) --> (<s> ^d00 <dv>)}
sp {dres0 (state <s> ^d00 <dv> ^superstate <sx>) (<sx> ^superstate <ss>)  --> (<sx> ^l05 <dv>)}
sp {res00 (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^spot <x0>) (<x0> ^size { <v0> <> 5 }) --> (<ss> ^done0 <r>) (<r> ^v (max <v0> <v0>) ^sub <q>) (<q> ^w <v0>)}
sp {adv1 (state <s> ^superstate nil ^done1 ^ph 1 ) --> (<s> ^ph 1 - ^ph 2)}
sp {loc10 (state <s> ^superstate <ss> ^impasse no-change ^attribute state) (<ss> ^ph 1) (<ss> ^box <x0>) (<x0> ^next <v0>) (<ss> ^spot <x1>) (<x1> ^next <v1>) --> (<s> ^l11 <v0>)}
sp {loc11 (state <s> ^superstate <ss> ^impasse no-change ^attribute state) (<ss> ^ph 1) (<s> ^l11 <x0>) (<x0> ^size { <v0> <> 5 }) --> (<s> ^l12 (+ <v0> 1))}
sp {res10 (state <s> ^superstate <ss>)  (<s> ^l11 <x0>) (<x0> ^size <v0>) --> (<ss> ^done1 <v0>)}
sp {res11 (state <s> ^superstate <ss> ^impasse no-change ^attribute state) (<ss> ^ph 1) (<s> ^l11 <x0>) (<x0> ^w <v0>) (<ss> ^size <v1>) (<ss> ^box.next <x2>) (<x2> ^next <v2>) (<s> -^nothere) --> (<ss> ^res11 (concat |n| <v0>))}
run 12
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
explain instantiation 11
explain wm-trace
explain instantiation 12
explain explanation-trace
explain chunk 2
explain formation
explain identity
explain constraints
explain stats
explain instantiation 7
explain wm-trace
explain instantiation 8
explain explanation-trace
explain chunk 3
explain formation
explain identity
explain constraints
explain stats
explain instantiation 4
explain wm-trace
explain instantiation 5
explain explanation-trace
print -d 3 s1
print -d 2 <s>
preferences s1 operator --names
production firing-counts
explain
