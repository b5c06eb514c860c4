# A test that compares with the substate itself (^superstate <=> <s>) says nothing above: the learned rule has no such test.
chunk always
sp {set*up (state <s> ^superstate nil) --> (<s> ^load 4 ^limit 9)}
sp {propose*lift (state <s> ^superstate.superstate nil) --> (<s> ^operator <o> +) (<o> ^name lift)}
sp {elaborate*copy (state <s> ^superstate <ss>) (<ss> ^load <x>) --> (<s> ^load <x>)}
sp {elaborate*checked (state <s> ^load <x> ^superstate <=> <s>) --> (<s> ^checked <x>)}
sp {elaborate*other (state <s> ^checked <x> ^superstate { <ss> <> <s> }) --> (<s> ^twice <x>)}
sp {apply*lift (state <s> ^operator.name lift ^checked <x> ^twice <x> ^superstate <ss>) (<ss> ^limit { < 20 <l> }) --> (<ss> ^lifted <x> <l>)}
watch 1
run 4
print --full --chunks
chunk stats
init-soar
run 2
print s1
