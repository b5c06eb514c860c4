chunk except
watch 0
source agent.soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -{ (<top> ^taken <t>) (<t> ^name <v>) } --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -(<top> ^taken.name <v>) --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -(<top> ^other <v>) --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -{ (<top> ^taken <t>) (<t> ^name > <v>) } --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -{ (<top> ^taken <t>) (<t> ^name <v> ^name <> <v>) } --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -{ (<top> ^taken <t>) (<t> ^<v> hi) } --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -{ (<x> ^taken <t>) (<t> ^name <v>) } --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
sp {low*free (state <s> ^name low ^superstate <ss>) (<ss> ^thing <x> ^superstate <top>) (<x> ^size <v>) -(<top> ^other { <> <v> < 9 }) --> (<ss> ^free <v>)}
run 6
print --full --chunks
excise --chunks
init-soar
