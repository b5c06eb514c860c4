# A result that hangs on an earlier result of the same substate gets the path to it, though it makes objects of its own; a negated conjunction that compares with an object of the substate is kept without that.
chunk always
sp {sub*op (state <s> ^superstate.superstate nil) --> (<s> ^operator.name fill)}
sp {sub*make (state <s> ^operator.name fill) --> (<s> ^box <b>) (<b> ^kind crate)}
sp {sub*give (state <s> ^operator.name fill ^box <b> ^superstate <ss>) --> (<s> ^given <b>) (<ss> ^box <b>)}
sp {sub*later (state <s> ^operator.name fill ^given <b> ^superstate <ss>) --> (<b> ^lid <l>) (<l> ^color red)}
trace 1
trace --learning fullprint
run 3
print --chunks --full
excise --all
init-soar
sp {top (state <s> ^superstate nil) --> (<s> ^size 8 ^weight 6 ^limit 7 ^height 23 ^width 23)}
sp {sub*op (state <s> ^superstate.superstate nil) --> (<s> ^operator.name weigh ^mark <m>)}
sp {sub*give (state <s> ^operator.name weigh ^superstate <ss> ^mark <m>) (<ss> ^size { > <b> <a> } ^weight <b>) -{(<ss> ^limit { < <m> > <a> > <b> <l> } ^height <l> ^width <a>)} -{(<ss> ^limit { <> <m> > <a> })} --> (<ss> ^largest <a> ^open <l>)}
run 3
print --chunks --full
