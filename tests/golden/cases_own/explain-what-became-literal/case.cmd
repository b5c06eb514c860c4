# explain shows the identity of an action's value that became literal, and no way to a result from firings that only selected an operator
watch 0
chunk always
explain all on
sp {yard*top (state <s> ^superstate nil) --> (<s> ^a 1 ^b 2 ^c 3)}
sp {yard*copy (state <s> ^superstate <ss>) (<ss> ^a <a>) --> (<s> ^a <a>)}
sp {yard*made (state <s> ^superstate <ss>) (<ss> ^b <b>) --> (<s> ^made box)}
sp {yard*tested (state <s> ^a 1) --> (<s> ^tested yes)}
sp {yard*sum (state <s> ^superstate <ss>) (<ss> ^c <c>) --> (<s> ^sum (+ <c> 1))}
sp {yard*tested-result (state <s> ^a <a> ^tested yes ^superstate { <ss> <> nil }) --> (<ss> ^r1 <a>)}
sp {yard*made-result (state <s> ^made <m> ^superstate { <ss> <> nil }) --> (<ss> ^r2 <m>)}
sp {yard*sum-result (state <s> ^sum <n> ^superstate { <ss> <> nil }) --> (<ss> ^r3 <n>)}
sp {yard*propose (state <s> ^superstate.superstate nil) --> (<s> ^operator <x> + <y> +) (<x> ^name lift) (<y> ^name lower)}
sp {yard*number (state <s> ^superstate <ss> ^operator <o> +) (<o> ^name lift) (<ss> ^b <b>) --> (<s> ^operator <o> = <b>)}
sp {yard*best (state <s> ^superstate <ss> ^operator <o> +) (<o> ^name lift) (<ss> ^c <c>) --> (<s> ^operator <o> >)}
sp {yard*apply (state <s> ^superstate <ss> ^operator <o>) (<o> ^name <n>) --> (<ss> ^done <n>)}
run 3
explain list-chunks
explain chunk 1
explain formation
explain identity
explain chunk 2
explain formation
explain identity
explain chunk 3
explain formation
explain identity
explain chunk 4
explain formation
explain identity
