# negated conditions in explanations, of a learned rule and of firings; both traces of the learned rule itself
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {cp (state <s> ^superstate <ss>) (<ss> ^box <b>) (<b> ^size <n> -^mark <m>) --> (<s> ^k <k>) (<k> ^n <n> ^b <b>)}
sp {fin (state <s> ^k <k> -^stop ^superstate <ss>) (<k> ^n <n> ^b <b>) -{(<b> ^next <x>) (<x> ^size > <n>)} --> (<ss> ^done <r>) (<r> ^n <n> ^in <q>) (<q> ^of <r>)}
watch 0
chunk always
explain all on
run 4
explain chunk 1
explain formation
explain identity
explain stats
explain wm-trace
explain instantiation 4
explain formation
explain chunk 1
explain explanation-trace
chunk stats
