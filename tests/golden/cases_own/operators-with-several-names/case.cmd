# Operators are printed with all their names, and those that evaluate objects with these.
sp {test*one (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name evaluate-object ^object 3 |a b| x)}
sp {test*two (state <s> ^superstate <ss>) (<ss> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name evaluate-object)}
sp {test*three (state <s> ^superstate <ss>) (<ss> ^superstate.superstate nil) --> (<s> ^operator <o> +) (<o> ^name evaluate-object ^object <s> <ss> <p>) (<p> ^name evaluate-object pump ^object <q>) (<q> ^name qq)}
sp {test*four (state <s> ^superstate <ss>) (<ss> ^superstate.superstate.superstate nil ^operator <oo>) --> (<s> ^operator <o> +) (<o> ^name evaluate-object other ^object <oo>)}
sp {test*five (state <s> ^superstate <ss>) (<ss> ^superstate.superstate.superstate.superstate nil) --> (<s> ^operator <o> +) (<o> ^name b a ^name c)}
sp {test*six (state <s> ^superstate <ss>) (<ss> ^superstate.superstate.superstate.superstate.superstate nil) --> (<s> ^operator <o> + ^name first ^name second) (<o> ^name <p> z) (<p> ^name pp rr)}
run 14
