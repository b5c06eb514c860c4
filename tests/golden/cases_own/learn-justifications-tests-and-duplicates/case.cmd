# A justification shows the tests of the reasoning behind it as a learned rule would, and statistics count them; one that was there already counts as a duplicate.
watch 0
chunk always
chunk allow-local-negations off
sp {yard*facts (state <s> ^superstate nil) --> (<s> ^load 5 ^limit 3 ^color red)}
sp {yard*copy (state <s> ^superstate <ss>) (<ss> ^load <l> ^limit <m>) --> (<s> ^load <l> ^limit <m> ^try 1 2 3 4 5)}
sp {yard*quiet (state <s> ^superstate <ss> ^quiescence t ^load { <l> > 2 < 9 > <m> << 5 7 >> } ^limit <m>) --> (<ss> ^quiet <l>)}
sp {yard*local (state <s> ^superstate { <ss> <> nil } ^load { <l> <= 6 <> <m> } ^limit { <m> < <l> } -^never t) --> (<ss> ^local <l>)}
sp {yard*again (state <s> ^superstate <ss> ^quiescence t ^try <t>) (<ss> ^color <c>) --> (<ss> ^again <c>)}
run 2
print --justifications --full
chunk stats
init-soar
chunk never
run 2
print --justifications --full
chunk stats
