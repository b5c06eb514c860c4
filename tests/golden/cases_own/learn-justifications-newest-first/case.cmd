# justifications that have names of rules: the newest is listed first
chunk only
sp {yard*init (state <s> ^superstate nil) --> (<s> ^crate <c1> <c2> <c3>) (<c1> ^load 7) (<c2> ^load 8) (<c3> ^load 9)}
sp {yard*count (state <s> ^superstate <ss>) (<ss> ^superstate nil ^crate <c>) (<c> ^load <n>) --> (<ss> ^seen <n>)}
sp {yard*name (state <s> ^superstate <ss>) (<ss> ^superstate nil ^crate <c>) (<c> ^load { <n> > 7 }) --> (<ss> ^heavy <c>)}
run 3
print --justifications
print --justifications --full
