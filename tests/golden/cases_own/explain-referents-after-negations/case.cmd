# variables of negated conditions are not counted
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1 ^k 2)}
sp {prop*a (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}
sp {prop*b (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}
sp {loc (state <s> ^superstate <ss>) (<ss> ^num <n>) -{(<ss> ^k <k>) (<k> ^deep <d>)} --> (<s> ^loc <n> ^list <new>) (<new> ^n <n>)}
sp {first (state <s> ^superstate <ss> ^loc <l>) --> (<ss> ^mid <l>) (<s> ^second <l>)}
sp {res (state <s> ^superstate <ss>) (<ss> ^operator <oa> + ^operator <ob> +) (<oa> ^name a) (<ob> ^name b) --> (<ss> ^operator <oa> > <ob>)}
run 2
explain chunk 1
explain formation
explain chunk 2
explain formation
