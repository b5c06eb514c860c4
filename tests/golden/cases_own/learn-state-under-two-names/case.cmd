# A rule is learned that knows one state by two variables: each of them is tested to be a state unless the other leads to it.
watch 0
chunk always
sp {top*facts (state <s> ^superstate nil) --> (<s> ^top-state <s> ^crane ready ^load 3 ^yard north)}
sp {sub*top (state <s> ^superstate <ss>) (<ss> ^top-state <ts>) --> (<s> ^top <ts>)}
sp {sub*crane (state <s> ^top <ts>) (<ts> ^crane <c>) --> (<s> ^crane-seen <c>)}
sp {sub*result (state <s> ^superstate <ss> ^top <ts> ^crane-seen <c>) (<ss> ^load <l>) --> (<ss> ^lift <c> <l>)}
run 3
print --chunks --full
excise --chunks
# Nothing leads from one to the other.
wm add s2 ^first s1
wm add s2 ^second s1
sp {sub*pair (state <s> ^first <a> ^second <b>) (<a> ^yard <y>) (<b> ^load <l>) --> (<b> ^pair <y> <l>)}
run 2
print --chunks --full
# Two states, known by names that do not lead to each other.
wm add s3 ^first s1
wm add s3 ^middle s2
wm add s2 ^gate open
sp {sub*levels (state <s> ^first <a> ^middle <b>) (<a> ^yard <y>) (<b> ^gate <g>) --> (<b> ^levels <y> <g>)}
run 2
print --chunks --full
print s1
chunk stats
