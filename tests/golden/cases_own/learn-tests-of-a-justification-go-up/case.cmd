# A comparison in a substate goes up through a justification: the rule that is learned above it asks for it, too.
chunk only
sp {top*facts (state <s> ^superstate nil) --> (<s> ^thing <t> ^shelf <h>) (<t> ^kind vase) (<h> ^holds vase)}
sp {learn-here (state <s> ^superstate.superstate nil) --> (force-learn <s>) (<s> ^operator.name dust)}
sp {mid*kind (state <s> ^superstate <ss>) (<ss> ^superstate nil ^thing.kind <k>) --> (<s> ^kind <k>)}
sp {low*result (state <s> ^superstate <m>) (<m> ^operator.name dust ^kind <k> ^superstate <t>) (<t> ^thing <x>) (<x> ^kind { <> cup <k> }) --> (<t> ^dusted <k>)}
trace 1
trace --learning fullprint
run 4
print --chunks --full
print --justifications --full
init-soar
chunk always
excise mid*kind
sp {mid*two (state <s> ^superstate.thing <x>) (<x> ^kind { <> jug <k> }) --> (<s> ^kind <k> ^thing <x>)}
sp {low*result (state <s> ^superstate <m>) (<m> ^operator.name dust ^thing <x> ^kind << vase pot >> ^superstate <t>) (<t> ^shelf { <> <x> <h> }) (<h> ^holds <k>) --> (<t> ^dusted <h>)}
chunk only
run 4
print --chunks --full
