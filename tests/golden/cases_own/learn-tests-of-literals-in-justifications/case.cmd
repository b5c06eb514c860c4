# a justification shows what a condition asked also where a sum has made the value a constant
chunk bottom-only on
chunk only
sp {yard*init (state <s> ^superstate nil) --> (<s> ^crate <c>) (<c> ^load 7 ^left 2 ^kind wood)}
sp {yard*sum (state <s> ^superstate <ss>) (<ss> ^crate <c>) (<c> ^load { <n> > 3 } ^left { <m> < <n> } ^kind << wood tin >>) --> (<s> ^sum (+ <n> <m>))}
sp {yard*done (state <s> ^superstate <ss> ^sum <x>) (<ss> ^superstate nil) --> (<ss> ^done <x>)}
run 2
print --justifications --full
