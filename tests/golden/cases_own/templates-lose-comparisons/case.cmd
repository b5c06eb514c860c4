sp {init (state <s> ^superstate nil) --> (<s> ^v 5 ^v 6 ^ob <x>) (<x> ^c red ^d 7)}
sp {prop (state <s> ^superstate nil ^ob <x>) --> (<s> ^operator <o> + =) (<o> ^name go ^x <x>)}
sp {tmpl :template (state <s> ^operator <o> + ^v { <v> > 1 <> 9 }) (<o> ^name go ^x <x>) (<x> ^c << red blue >> ^d { <d> <> <v> }) --> (<s> ^operator <o> = 1.5)}
watch 0
rl --set learning on
run 2
print --rl
print rl*tmpl*1
