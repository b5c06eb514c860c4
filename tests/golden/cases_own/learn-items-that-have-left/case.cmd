# An item of a tie that has left because its operator is out of the running still rests on the operator's proposal.
chunk always
sp {top (state <s> ^superstate nil) --> (<s> ^operator <a> + ^operator <b> + ^operator <d> + ^operator <e> +) (<a> ^name walk ^cost 3) (<b> ^name ride ^cost 3) (<d> ^name fly ^cost 5) (<e> ^name swim ^cost 3)}
sp {sel*propose (state <s> ^impasse tie ^item <i>) -{(<s> ^value <v>) (<v> ^about <i> ^done t)} --> (<s> ^operator <o> + =) (<o> ^name check ^about <i>)}
sp {sel*apply (state <s> ^operator <o>) (<o> ^name check ^about <i>) --> (<s> ^value <v>) (<v> ^about <i>)}
sp {sel*link (state <s> ^operator <o> ^value <v>) (<o> ^about <i>) (<v> ^about <i>) --> (<o> ^value <v>)}
sp {sel*done (state <s> ^value <v>) (<v> ^cost) --> (<v> ^done t)}
sp {eval*cost (state <s> ^superstate <ss>) (<ss> ^operator <o>) (<o> ^name check ^about <i> ^value <v>) (<i> ^cost <c>) --> (<v> ^cost <c>)}
sp {sel*result (state <s> ^value <v> ^value { <> <v> <w> } ^superstate <ss>) (<v> ^about <x> ^cost <c>) (<w> ^about <y> ^cost <c>) --> (<ss> ^operator <x> = <y>)}
sp {sel*worse (state <s> ^value <v> ^value { <> <v> <w> } ^superstate <ss>) (<v> ^about <x> ^cost <c>) (<w> ^about <y> ^cost < <c>) --> (<ss> ^operator <x> < <y>)}
trace 1
trace --learning fullprint
decide indifferent-selection --first
run 12
excise --all
init-soar
chunk never
decide indifferent-selection --last
chunk never
sp {top (state <s> ^superstate nil) --> (<s> ^operator <a> + ^operator <b> + ^operator <d> + ^operator <e> +) (<a> ^name walk ^cost 3) (<b> ^name ride ^cost 3) (<d> ^name fly ^cost 5) (<e> ^name swim ^cost 3)}
sp {sel*propose (state <s> ^impasse tie ^item <i>) -{(<s> ^value <v>) (<v> ^about <i> ^done t)} --> (<s> ^operator <o> + =) (<o> ^name check ^about <i>)}
sp {sel*apply (state <s> ^operator <o>) (<o> ^name check ^about <i>) --> (<s> ^value <v>) (<v> ^about <i>)}
sp {sel*link (state <s> ^operator <o> ^value <v>) (<o> ^about <i>) (<v> ^about <i>) --> (<o> ^value <v>)}
sp {sel*done (state <s> ^value <v>) (<v> ^cost) --> (<v> ^done t)}
sp {eval*cost (state <s> ^superstate <ss>) (<ss> ^operator <o>) (<o> ^name check ^about <i> ^value <v>) (<i> ^cost <c>) --> (<v> ^cost <c>)}
sp {sel*result (state <s> ^value <v> ^value { <> <v> <w> } ^superstate <ss>) (<v> ^about <x> ^cost <c>) (<w> ^about <y> ^cost <c>) --> (<ss> ^operator <x> = <y>)}
sp {sel*worse (state <s> ^value <v> ^value { <> <v> <w> } ^superstate <ss>) (<v> ^about <x> ^cost <c>) (<w> ^about <y> ^cost < <c>) --> (<ss> ^operator <x> < <y>)}
run 12
