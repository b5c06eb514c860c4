# only, except and bottom-only tell for each firing that its state is left out
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {lo (state <s> ^superstate.superstate nil) --> (<s> ^operator.name deeper)}
sp {three (state <s> ^superstate.superstate.superstate nil ^superstate <ss>) --> (<ss> ^from three)}
sp {fin (state <s> ^superstate <ss> ^superstate.superstate nil) (<ss> ^level <l>) --> (<ss> ^done <l>)}
sp {late (state <s> ^from three ^superstate <ss>) (<ss> ^level <l>) --> (<ss> ^late <l>)}
watch 1
trace --learning 1
trace --chunk-warnings
chunk only
run 4
init-soar
chunk except
sp {not (state <s> ^superstate.superstate nil) --> (dont-learn <s>)}
run 4
init-soar
excise not
chunk always
chunk bottom-only on
run 5
chunk stats
