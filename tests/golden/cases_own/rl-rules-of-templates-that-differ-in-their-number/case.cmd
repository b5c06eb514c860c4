# rules that templates make are duplicates whatever chunk-stop says; numbers go on behind rules called rl*NAME*n
rl --set learning on
sp {init (state <s> ^superstate nil) --> (<s> ^cell 1 ^color red)}
sp {prop*left (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name left)}
sp {prop*right (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name right)}
sp {tmpl*2 :template (state <s> ^operator <o> + ^cell <c> ^color <col>) (<o> ^name right) --> (<s> ^operator <o> = 0.0)}
sp {tmpl*3 :template (state <s> ^operator <o> + ^cell <c> ^color <col>) (<o> ^name right) --> (<s> ^operator <o> = 2.25)}
sp {tmpl*4 :template (state <s> ^operator <o> + ^cell <c> ^color <col>) (<o> ^name left) --> (<s> ^operator <o> = 2.25)}
sp {tmpl*5 :template (state <s> ^operator <o> + ^cell <c> ^color <col>) (<o> ^name <x>) --> (<s> ^operator <o> = 2.25)}
run 1
print --rl
rl --set chunk-stop off
wm add s1 ^color blue
run 1
print --rl
sp {tmpl*3 :template (state <s> ^operator <o> + ^cell <c> ^color <col>) (<o> ^name right) --> (<s> ^operator <o> = 3.25)}
wm add s1 ^color green
run 1
print --rl
init-soar
run 1
print --rl
sp {rl*foo*50 (state <s> ^operator <o> + ^cellx <c>) --> (<s> ^operator <o> = 2.25)}
wm add s1 ^color white
run 1
print --rl
