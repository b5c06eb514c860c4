# numbered names: chunks and justifications count by themselves, past names that there are
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {chunk3 (state <s> ^never) --> (<s> ^x 1)}
sp {cp (state <s> ^superstate <ss>) (<ss> ^box <b>) (<b> ^size <n>) --> (<s> ^n <n>)}
sp {j (state <s> ^quiescence t ^n <n> ^superstate <ss>) --> (<ss> ^j <n>)}
sp {fin (state <s> ^n <n> ^superstate <ss>) --> (<ss> ^<n> <n>)}
watch 0
trace --learning 1
chunk always
chunk naming-style numbered
run 4
init-soar
run 4
print --chunks
