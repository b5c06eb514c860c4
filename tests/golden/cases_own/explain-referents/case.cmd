# a referent has the number of its variable in the learned rule
watch 0
chunk always
explain all on
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^ph 0)}
sp {prop*a (state <s> ^superstate nil ^ph <p>) --> (<s> ^operator <o> +) (<o> ^name a ^p <p>)}
sp {prop*b (state <s> ^superstate nil ^ph <p>) --> (<s> ^operator <o> +) (<o> ^name b ^p <p>)}
sp {apply (state <s> ^operator <o> ^ph <p>) (<o> ^name a) --> (<s> ^ph <p> - ^ph (+ <p> 1))}
sp {res*1 (state <s> ^superstate <ss> ) (<ss> ^operator <oa> + ^operator <ob> + ^ph 0) (<oa> ^name a) (<ob> ^name b) --> (<ss> ^operator <oa> > <ob>)}
sp {res*2 (state <s> ^superstate <ss> ) (<ss> ^operator <oa> + ^operator <ob> + ^ph 1) (<oa> ^name a) (<ob> ^name b) --> (<ss> ^operator <oa> > <ob>)}
sp {res*3 (state <s> ^superstate <ss> ) (<ss> ^operator <oa> + ^operator <ob> + ^ph { <x> 2 }) (<oa> ^name a) (<ob> ^name b) --> (<ss> ^operator <oa> > <ob>)}
run 8
explain chunk 1
explain formation
explain chunk 2
explain formation
explain chunk 3
explain formation
