# what learning traces back, with trace --backtracing
decide srand 2
chunk always
watch --backtracing
sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}
sp {r (state <s> ^superstate <ss>) (<ss> ^operator.name a) --> (<ss> ^res t)}
run 3
