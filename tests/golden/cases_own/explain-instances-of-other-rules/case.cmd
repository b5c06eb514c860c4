# an earlier rule's instance has made its results, a later one's has not yet
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1 ^k 2)}
sp {one (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^one <n>)}
sp {two (state <s> ^superstate <ss>) (<ss> ^k <k>) --> (<ss> ^two <k>)}
run 2
explain chunk 1
explain instantiation 3
explain instantiation 4
explain instantiation 5
explain instantiation 6
explain chunk 2
explain instantiation 3
explain instantiation 4
explain instantiation 5
explain instantiation 6
