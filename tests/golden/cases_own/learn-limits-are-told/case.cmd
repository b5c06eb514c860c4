# what max-chunks and max-dupes keep from being learned is told; duplicates are counted on across init-soar
sp {world (state <s> ^superstate nil) --> (<s> ^box <b> <c> ^level 4 ^flag yes) (<b> ^size 7 ^w 3 ^color red ^next <c>) (<c> ^size 2 ^w 5 ^color blue ^next <b>)}
sp {go (state <s> ^superstate nil) --> (<s> ^operator.name go)}
sp {cp (state <s> ^superstate <ss>) (<ss> ^box <b>) (<b> ^size <n>) --> (<s> ^n <n>)}
sp {fin (state <s> ^n <n> ^superstate <ss>) --> (<ss> ^done t ^n <n>)}
watch 1
trace --learning 1
trace --chunk-warnings
chunk always
chunk max-dupes 1
run 4
init-soar
run 4
init-soar
chunk max-chunks 1
excise --chunks
run 4
chunk stats
