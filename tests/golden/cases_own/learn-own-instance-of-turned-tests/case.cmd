# what is learned from a learned rule's own instance: a comparison that was turned round when that rule was put in order compares a value with itself, so the second rule never matches; one that was not turned is right
chunk always
sp {yard*init (state <s> ^superstate nil) --> (<s> ^crate <c0> <c1> <c2>) (<c0> ^n 0) (<c1> ^n 1) (<c2> ^n 2)}
sp {yard*copy (state <s> ^superstate <ss>) (<ss> ^crate <c>) --> (<s> ^crate <c>)}
sp {yard*load (state <s> ^superstate <ss>) (<ss> ^crate <c>) (<c> ^n <n>) --> (<s> ^load <n>)}
sp {yard*done (state <s> ^superstate.superstate.superstate nil ^superstate <ss>) (<s> ^stack <x>) (<ss> ^superstate <top>) --> (<top> ^stacked <x>)}
sp {yard*turned (state <s> ^superstate <ss>) (<ss> ^crate <x>) (<x> ^n 0) (<ss> ^crate <y>) (<y> ^n 1) (<ss> ^crate { <z> <> <y> }) (<z> ^n 0) --> (<s> ^stack <new>)}
run 3
print --chunks --full
chunk stats
excise yard*turned
excise --chunks
init-soar
sp {yard*as-is (state <s> ^superstate <ss>) (<ss> ^crate <y>) (<y> ^n 1) (<ss> ^crate <w>) (<w> ^n 2) (<ss> ^crate { <x> <> <w> }) (<x> ^n 0) (<ss> ^crate { <z> <> <y> }) (<z> ^n 0) --> (<s> ^stack <new>)}
run 3
print --chunks --full
excise yard*as-is
excise --chunks
init-soar
sp {yard*both (state <s> ^superstate <ss>) (<ss> ^load { <x> << 0 7 >> }) (<ss> ^load { <y> << 1 8 >> }) (<ss> ^load { <z> <> <y> <= <x> << 0 9 >> }) --> (<s> ^stack <new>)}
run 3
print --chunks --full
explain chunk 1
