# behind each item of an impasse stands a firing of the architecture: explain shows it, and chunk stats counts it
watch 0
chunk always
explain all on
sp {quay*init (state <s> ^superstate nil) --> (<s> ^num 1)}
sp {quay*propose*a (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}
sp {quay*propose*b (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}
sp {quay*propose*c (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name c)}
sp {quay*better (state <s> ^item <i1> ^item <i2> ^superstate <ss>) (<i1> ^name a) (<i2> ^name b) --> (<ss> ^operator <i1> > <i2>)}
sp {quay*number (state <s> ^item <i1> ^non-numeric <i2> ^superstate <ss>) (<i1> ^name b) (<i2> ^name c) --> (<ss> ^operator <i1> = 5 ^three <i2>)}
sp {quay*count (state <s> ^item-count <i1> ^non-numeric <i2> ^superstate <ss>) (<i2> ^name a) --> (<ss>  ^four <i2> <i1>)}
sp {quay*sum (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^sum (+ <n> 1))}
run 2
explain chunk 1
explain identity
explain instantiation 5
explain wm-trace
explain formation
explain explanation-trace
explain chunk 2
explain formation
explain identity
explain chunk 3
explain formation
explain identity
explain instantiation 10
explain chunk 4
explain formation
explain
run 3
chunk stats
print --chunks --full
