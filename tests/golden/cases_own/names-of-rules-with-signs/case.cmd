# The trace prints short names of rules with signs in them in bars, as it prints such symbols.
sp {r*i (state <s> ^superstate nil) --> (<s> ^a 1 ^b 2)}
sp {a-b (state <s> ^a <v>) --> (<s> ^c <v>)}
sp {x*yz (state <s> ^b <v> -^e) --> (<s> ^d <v>)}
sp {z*z (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name o)}
sp {ap* (state <s> ^operator.name o) --> (<s> ^e 1)}
sp {tie (state <s> ^superstate <ss>) --> (<ss> ^f 1)}
watch 5
run 2
excise a-b
run 1
