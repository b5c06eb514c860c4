# three firings prohibit one operator: the rule learned from what was selected instead tests what each of them rests on, with add-osk off, too
chunk always
decide indifferent-selection --first
sp {yard*init (state <s> ^superstate nil) --> (<s> ^crate <c1> <c2> <c3>) (<c1> ^load 7) (<c2> ^load 8) (<c3> ^load 9)}
sp {yard*propose*lift (state <s> ^superstate.superstate nil ^impasse no-change) --> (<s> ^operator <o> +, =) (<o> ^name lift)}
sp {yard*propose*push (state <s> ^superstate.superstate nil ^impasse no-change) --> (<s> ^operator <o> +, =) (<o> ^name push)}
sp {yard*propose*wait (state <s> ^superstate.superstate nil ^impasse no-change) --> (<s> ^operator <o> +, =) (<o> ^name wait)}
sp {yard*too*heavy (state <s> ^superstate <ss> ^operator <o> +) (<o> ^name lift) (<ss> ^crate <c>) (<c> ^load > 6) --> (<s> ^operator <o> ~)}
sp {yard*done (state <s> ^operator.name <n> ^superstate <ss>) (<ss> ^superstate nil) --> (<ss> ^done <n>)}
run 3
print --chunks --full
excise --chunks
chunk add-osk off
init-soar
run 3
print --chunks --full
