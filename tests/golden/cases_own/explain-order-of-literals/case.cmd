# a generated agent: explain order of literals
watch 0
chunk always
explain all on
explain justifications on
chunk max-dupes 1
decide indifferent-selection --first
soar max-elaborations 30
trace --learning 1
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0) (<s> ^num 3 ^flag red ^size 9 ^box <b0> ^box <b1> ^box <b2> ^spot <b0>) (<b0> ^size 9 ^w 4 ^kind blue ^next <b1>) (<b0> ^w 2) (<b1> ^size 8 ^w 4 ^kind red ^next <b2>) (<b2> ^size 9 ^w 3 ^kind green ^next <b0>) (<b2> ^w 7)}
sp {prop0 (state <s> ^superstate nil ^ph 0) --> (<s> ^operator <o> +) (<o> ^name go0)}
sp {adv0 (state <s> ^superstate nil ^done0 ^ph 0 ^operator.name go0) --> (<s> ^ph 0 - ^ph 1)}
sp {tag0 (state <s> ^superstate <ss> ^impasse no-change) (<ss> ^operator.name go0) (<ss> ^superstate nil) --> (<s> ^tag p0)}
sp {loc00 (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^spot <x0>) (<x0> ^size <v0>) (<ss> ^size <v1>) --> (<s> ^l01 <v1>)}
sp {loc01 (state <s> ^tag p0 ^superstate <ss>)  (<s> ^l01 <v0>) --> (<s> ^l02 <st>) (<st> ^v <v0> ^k (max <v0> <v0>))}
sp {loc02 (state <s> ^tag p0 ^superstate <ss>)  (<ss> ^num <v0>) --> (<s> ^l03 (max <v0> <v0>) ^l04 (+ <v0> <v0>))}
sp {res00 (state <s> ^l02 <st> ^tag p0 ^superstate <ss>)  (<s> ^l02 <x0>) (<x0> ^v <v0>) --> (<ss> ^done0 <st>)}
sp {grow00 (state <s> ^l02 <st> ^tag p0 ^superstate <ss>)  (<ss> ^done0) (<ss> ^box <x0>) (<x0> ^size { <v0> > 0 }) -{(<s> ^nowhere <nb>) (<nb> ^kind black)} --> (<st> ^grown <v0>)}
sp {use00 (state <s> ^l02 <st> ^tag p0 ^superstate <ss>)  (<st> ^v <uv>) (<ss> ^done0) --> (<ss> ^used0 <uv>)}
sp {res01 (state <s> ^l02 <st> ^tag p0 ^superstate <ss>)  (<ss> ^num <v0>) --> (<ss> ^done0 <st>)}
sp {grow01 (state <s> ^l02 <st> ^tag p0 ^superstate <ss>)  (<ss> ^done0) (<ss> ^num <v0>) --> (<st> ^grown <v0>)}
sp {res02 (state <s> ^tag p0 ^superstate <ss>)  (<s> ^l04 { <v0> <= 9 }) (<s> ^l03 <v1>) --> (<ss> ^done0 <v0> ^extra2 <v0>)}
run 4
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
explain instantiation 10
explain wm-trace
explain instantiation 11
explain explanation-trace
explain chunk 3
explain formation
explain identity
explain constraints
explain stats
explain instantiation 3
explain wm-trace
explain instantiation 4
explain explanation-trace
explain chunk 4
explain formation
explain identity
explain constraints
explain stats
explain instantiation 14
explain wm-trace
explain instantiation 15
explain explanation-trace
print -d 3 s1
print -d 2 <s>
preferences s1 operator --names
production firing-counts
explain
