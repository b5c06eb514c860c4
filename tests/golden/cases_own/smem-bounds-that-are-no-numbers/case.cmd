# Bounds of a query that are no numbers fail, unknown tests are passed over, bounds alone find nothing.
smem --enable
smem --add {(@1 ^kind jar ^size 4 ^height 2) (@2 ^kind jar ^size 9 ^height 7)}
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query <q> ^math-query <m>) (<q> ^kind jar) (<m> ^size <x>) (<x> ^max <y>)}
run 2
print L1 -d 3
init-soar
run 2
print L1 -d 3
init-soar
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query <q> ^math-query <m>) (<q> ^kind jar) (<m> ^size.max <y> ^height.greater 3)}
run 2
print L1 -d 3
init-soar
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query <q> ^math-query <m>) (<q> ^kind jar) (<m> ^size.less <y>)}
run 2
print L1 -d 3
init-soar
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query <q> ^math-query <m>) (<q> ^kind jar) (<m> ^size.least 3)}
run 2
print L1 -d 3
init-soar
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query <q> ^math-query <m>) (<m> ^size.max 1)}
run 2
print L1 -d 3
