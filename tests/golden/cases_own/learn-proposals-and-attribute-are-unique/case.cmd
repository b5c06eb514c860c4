# Two conditions on one proposal of a state above are about one operator, unless singletons are not found automatically; what the architecture says in ^attribute is unique.
chunk always
sp {top (state <s> ^superstate nil) --> (<s> ^operator <a> + ^operator <b> + ^operator <c> +) (<a> ^name walk ^cost 3) (<b> ^name ride ^cost 3) (<c> ^name swim ^cost 9)}
sp {sub*same (state <s> ^item <x> ^item { <> <x> <y> } ^superstate <ss>) (<x> ^cost <c>) (<y> ^cost <c>) --> (<ss> ^operator <x> = <y>)}
sp {sub*seen (state <s> ^impasse tie ^superstate <ss>) (<ss> ^operator <x> + ^operator <y> +) (<x> ^name walk) (<y> ^name ride) --> (<s> ^seen <x>)}
sp {sub*best (state <s> ^seen <x> ^superstate <ss>) (<ss> ^operator <x> + ^operator { <> <x> <z> } +) (<z> ^cost > 4) --> (<ss> ^dull <z>)}
sp {sub*both (state <s> ^seen <x> ^item <x> ^item <y> ^superstate <ss>) (<x> ^cost <c>) (<y> ^cost <c> ^name ride) --> (<ss> ^even <y>)}
trace 1
trace --learning fullprint
run 3
print --chunks --full
excise --all
init-soar
chunk automatically-create-singletons off
sp {top (state <s> ^superstate nil) --> (<s> ^operator <a> + ^operator <b> + ^operator <c> +) (<a> ^name walk ^cost 3) (<b> ^name ride ^cost 3) (<c> ^name swim ^cost 9)}
sp {sub*one (state <s> ^impasse tie ^superstate <ss>) (<ss> ^operator <x> +) (<x> ^name walk) --> (<s> ^one yes)}
sp {sub*two (state <s> ^impasse tie ^superstate <ss>) (<ss> ^operator <x> +) (<x> ^name walk ^cost <c>) --> (<s> ^two <c>)}
sp {sub*both (state <s> ^one yes ^two <c> ^superstate <ss>) --> (<ss> ^even <c>)}
run 3
excise --all
init-soar
chunk automatically-create-singletons off
sp {s*a (state <s> ^superstate.superstate nil ^superstate <ss>) --> (<s> ^ready yes)}
sp {s*one (state <s> ^superstate <ss> ^superstate.superstate.superstate nil) (<ss> ^attribute <a> ^choices <c> ^quiescence <q> ^impasse <i> ^type <t> ^smem <m> ^epmem <e> ^reward-link <r> ^superstate <x>) --> (<s> ^one yes)}
sp {s*two (state <s> ^superstate <ss> ^one yes) (<ss> ^attribute <a> ^choices <c> ^quiescence <q> ^impasse <i> ^type <t> ^smem <m> ^epmem <e> ^reward-link <r> ^superstate <x>) --> (<ss> ^found yes)}
run 4
