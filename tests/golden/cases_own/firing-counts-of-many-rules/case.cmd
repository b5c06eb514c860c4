# the order of rules with equal counts among many; rules of reinforcement learning and justifications are kinds of their own
watch 0
sp {user1x (state <s> ^superstate nil) --> (<s> ^a 1 ^b 2)}
sp {def1x :default (state <s> ^never 1) --> (<s> ^zz 1)}
sp {rl1x (state <s> ^operator <o> + ^a 4) --> (<s> ^operator <o> = 1)}
sp {chu1x :chunk (state <s> ^never 3) --> (<s> ^a 3)}
sp {tem1x :template (state <s> ^operator <o> + ^a <a>) --> (<s> ^operator <o> = 1)}
sp {user3x (state <s> ^never 4) --> (<s> ^a 4)}
sp {rl2x (state <s> ^operator <o> + ^a 7) --> (<s> ^operator <o> = 1)}
sp {rl3x :default (state <s> ^operator <o> + ^a 8) --> (<s> ^operator <o> = 1)}
sp {rl4x :chunk (state <s> ^operator <o> + ^a 9) --> (<s> ^operator <o> = 1)}
sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> +)}
sp {harbour*crane (state <s> ^superstate nil ^a 0) --> (<s> ^seen0 t)}
sp {harbour*quay (state <s> ^superstate nil ^a 1) --> (<s> ^seen1 t)}
sp {harbour*mole (state <s> ^superstate nil ^a 2) --> (<s> ^seen2 t)}
sp {harbour*buoy (state <s> ^superstate nil ^a 3) --> (<s> ^seen3 t)}
sp {harbour*dock (state <s> ^superstate nil ^a 0) --> (<s> ^seen4 t)}
sp {harbour*pilot (state <s> ^superstate nil ^a 1) --> (<s> ^seen5 t)}
sp {harbour*tug (state <s> ^superstate nil ^a 2) --> (<s> ^seen6 t)}
sp {harbour*rope (state <s> ^superstate nil ^a 3) --> (<s> ^seen7 t)}
sp {harbour*anchor (state <s> ^superstate nil ^a 0) --> (<s> ^seen8 t)}
sp {harbour*chart (state <s> ^superstate nil ^a 1) --> (<s> ^seen9 t)}
rl --set learning on
sp {subq (state <s> ^superstate <ss> ^quiescence t) (<ss> ^a <a>) --> (<ss> ^got <a>)}
chunk always
sp {sub (state <s> ^superstate <ss>) (<ss> ^b <a>) --> (<ss> ^gotb <a>)}
run 3
sp {user5x (state <s> ^never 8) --> (<s> ^a 8)}
production firing-counts
firing-counts --user
firing-counts --chunks
firing-counts --rl
firing-counts --template
firing-counts --justifications
firing-counts --default
firing-counts -r -u
print
print --user
print --rl
print --template
print --default
print --chunks
print --all
production memory-usage
memories --user
memories --chunks
memories --template
memories --default
firing-counts 5
firing-counts 0
production memory-usage 3
