# what the architecture says of a substate is an identity like others: constants of actions, tests above, variables of negations
watch 0
chunk always
explain all on
sp {dock*init (state <s> ^superstate nil) --> (<s> ^num 2 ^kind tie ^box <b>) (<b> ^num 2 ^kind tie ^size 3)}
sp {dock*propose*a (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name a)}
sp {dock*propose*b (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name b)}
sp {dock*two (state <s> ^superstate <ss> ^impasse <i>) (<ss> ^kind <i> ^box <b>) (<b> ^kind <i>) --> (<ss> ^two <i>)}
sp {dock*copy (state <s> ^superstate <ss> ^impasse <i> ^item-count <c> ^attribute <a>) --> (<s> ^imp <i> ^cnt <c> ^att <a>)}
sp {dock*three (state <s> ^superstate <ss> ^imp <i> ^cnt <c>) (<ss> ^box <b>) (<b> ^num <c> ^size > <c>) --> (<b> ^three <c> <i>)}
sp {dock*four (state <s> ^superstate <ss> ^imp tie ^att <a>) (<ss> ^num <c> -^kind <a>) --> (<ss> ^four <c> <a>)}
sp {dock*five (state <s> ^superstate <ss> ^item-count <k>) (<ss> ^num <c> -^numm <k>) --> (<ss> ^five <c>)}
run 3
print --chunks --full
chunk stats
explain chunk 1
explain formation
explain chunk 2
explain formation
explain chunk 3
explain formation
explain chunk 4
explain formation
