# rules of the other kind count among those that are not listed
watch 0
chunk always
explain all on
explain justifications on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1 ^k 2)}
sp {one (state <s> ^superstate <ss>) (<ss> ^num <n>) --> (<ss> ^one <n>)}
sp {two (state <s> ^superstate <ss> ^quiescence t) (<ss> ^k <k>) --> (<ss> ^two <k>)}
run 2
explain
explain list-chunks
explain list-justifications
