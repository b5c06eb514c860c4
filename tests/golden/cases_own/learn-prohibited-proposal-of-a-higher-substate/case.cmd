# the same where only a proposal is tested; the second rule comes from the second proposal
watch 0
chunk always
sp {init (state <s> ^superstate nil) --> (<s> ^name top ^num 1)}
sp {prop0 (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go0)}
sp {lprop0a (state <s> ^superstate <ss>)  (<ss> ^num <v0>) --> (<s> ^operator <o> + ) (<o> ^name lo0a ^val <v0>)}
sp {lprop0b (state <s> ^superstate <ss>)  (<ss> ^num <v0>) --> (<s> ^operator <o> + =) (<o> ^name lo0b ^val <v0>)}
sp {lpref00 (state <s> ^operator <o> +) (<o> ^name lo0b) --> (<s> ^operator <o> ~)}
sp {dres0 (state <s> ^superstate <sx>) (<sx> ^superstate <ss>) (<sx> ^operator <oo> +) (<oo> ^val <zz>) --> (<sx> ^l03 <zz>)}
run 5
print --chunks --full
