# negated conjunctions that follow each other share their braces where elements are shown
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1)}
sp {loc (state <s> ^superstate <ss>) (<ss> ^num <n>) -{(<ss> ^k <k>) (<k> ^deep <d>)} --> (<s> ^loc <n>)}
sp {res (state <s> ^superstate <ss> ^loc <l>) -{(<ss> ^other <k>) (<k> ^deep <d>)} --> (<ss> ^mid <l>)}
run 2
explain chunk 1
explain wm-trace
