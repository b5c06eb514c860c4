source agent.soar
watch 0
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^max.size <x>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size.nothing <x>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^weight.max <x>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^weight.less 5 ^size.less 8)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size 7)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size <x>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size.max <x> ^cost.max <y>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size.min <x> ^cost.min <y>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size.min <x> ^cost.max <y>)}
run 2
print s1 -d 4
init-soar
excise ask
sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind b ^math-query <m>) (<m> ^size <n>) (<n> ^max <x> ^min <y>)}
run 2
print s1 -d 4
init-soar
excise ask
