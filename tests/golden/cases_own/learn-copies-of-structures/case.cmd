# deep-copy in a substate: what was copied is tested by the learned rule, which gives the original, and by justifications
trace 1
chunk always
watch --learning 2
sp {map*init (state <s> ^superstate nil) --> (<s> ^plan <p>) (<p> ^step <t1> <t2> ^n 3) (<t1> ^act go) (<t2> ^act stop ^next <t1>)}
sp {map*propose (state <s> ^superstate nil -^copy) --> (<s> ^operator.name go)}
sp {map*copy (state <s> ^superstate <ss>) (<ss> ^plan <p> ^operator.name go) --> (<ss> ^copy (deep-copy <p>))}
run 3
print --chunks --full
print s1 -d 4
excise map*copy
init-soar
run 3
print s1 -d 4
excise --chunks
sp {map*copy*among*others (state <s> ^superstate <ss>) (<ss> ^plan <p> ^operator.name go) --> (<ss> ^a 1) (<ss> ^copy (deep-copy <p>)) (<ss> ^b 2)}
chunk never
init-soar
run 3
print --justifications --full
print s1 -d 4
