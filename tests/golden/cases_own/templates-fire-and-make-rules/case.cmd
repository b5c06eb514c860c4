sp {init (state <s> ^superstate nil) --> (<s> ^v 5 ^v 6 ^ob <x>) (<x> ^c red ^d 7)}
sp {prop (state <s> ^superstate nil ^ob <x>) --> (<s> ^operator <o> + =) (<o> ^name go ^x <x>)}
sp {tmpl :template (state <s> ^operator <o> + ^v <v>) (<o> ^name go ^x <x>) (<x> ^c <c> ^d <d>) --> (<s> ^operator <o> = 1.5)}
sp {bump (state <s> ^operator <o>) --> (<s> ^v 7)}
watch 0
trace 3
rl --set learning on
run 2
print --rl
print rl*tmpl*1
print rl*tmpl*3
init-soar
run 1
print --rl
excise tmpl
print --rl
