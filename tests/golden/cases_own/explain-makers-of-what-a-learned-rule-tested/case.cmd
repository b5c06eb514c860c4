# what a learned rule's own instance tested in a substate was made by firings, named if an explanation has them
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1)}
sp {prop (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}
sp {lprop (state <s> ^superstate <ss>) (<ss> ^operator.name go ^num <n>) --> (<s> ^operator <o> +) (<o> ^name lo ^val <n>)}
sp {deep (state <s> ^superstate <sx> ^impasse no-change) (<sx> ^operator <lo> ^superstate <ss>) (<lo> ^val <lv>) (<ss> ^num <n>) --> (<s> ^d <n>)}
sp {dres (state <s> ^d <n> ^superstate <sx>) --> (<sx> ^r <n>)}
sp {res (state <s> ^r <n> ^superstate <ss>) (<ss> ^operator.name go) --> (<ss> ^done <n>)}
run 4
explain chunk 1
explain wm-trace
explain explanation-trace
explain chunk 2
explain formation
