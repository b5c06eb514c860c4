# explain shows the shortest way to a result from firings that no earlier explanation has
watch 0
chunk always
explain all on
sp {yard*top (state <s> ^superstate nil) --> (<s> ^a 1 ^b 2 ^c 3)}
sp {yard*copy (state <s> ^superstate <ss>) (<ss> ^a <a>) --> (<s> ^a <a>)}
sp {yard*step1 (state <s> ^a <a>) --> (<s> ^a1 <a>)}
sp {yard*step2 (state <s> ^a <a> ^superstate.b <b>) --> (<s> ^a2 <a> ^b2 <b>)}
sp {yard*res1 (state <s> ^a1 <a> ^superstate { <ss> <> nil }) (<ss> ^c <c>) --> (<ss> ^r1 <a> <c>)}
sp {yard*res2 (state <s> ^a2 <a> ^b2 <b> ^superstate { <ss> <> nil }) --> (<ss> ^r2 <a> <b>)}
sp {yard*res3 (state <s> ^a <a> ^superstate { <ss> <> nil }) (<ss> ^c <c>)  --> (<ss> ^r3 <a> <c>)}
run 2
explain chunk 1
explain explanation-trace
explain instantiation 3
explain chunk 2
explain instantiation 3
explain instantiation 3
explain instantiation 4
explain chunk 3
explain instantiation 3
