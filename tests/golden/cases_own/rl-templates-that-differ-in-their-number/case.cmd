# rules and templates that differ only in their number are duplicates while chunk-stop is on
sp {aone (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = 0.0)}
sp {atwo (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = 2.0)}
sp {athree :template (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = 3.0)}
sp {afour :template (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = 4.0)}
sp {afive (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = <c>)}
sp {asix :template (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = <c>)}
sp {aseven (state <s> ^operator <o> + ^cell <c>) --> (<s> ^operator <o> = (+ <c> 1))}
sp {bone :template (state <s> ^operator <o> + ^cellb <c>) --> (<s> ^operator <o> = 0.0)}
sp {btwo (state <s> ^operator <o> + ^cellb <c>) --> (<s> ^operator <o> = 1.0)}
sp {bthree :template (state <s> ^operator <o> + ^cellb <c>) --> (<s> ^operator <o> = <c>)}
sp {bfour :template (state <s> ^operator <o> + ^cellb <c>) --> (<s> ^operator <o> = <o>)}
sp {cone :template (state <s> ^operator <o> + ^cellc <c>) --> (<s> ^operator <o> = <c>)}
sp {ctwo :template (state <s> ^operator <o> + ^cellc <c>) --> (<s> ^operator <o> = 1)}
sp {cthree (state <s> ^operator <o> + ^cellc <c>) --> (<s> ^operator <o> = 1)}
rl --set chunk-stop off
sp {done (state <s> ^operator <o> + ^celld <c>) --> (<s> ^operator <o> = 0.0)}
sp {dtwo (state <s> ^operator <o> + ^celld <c>) --> (<s> ^operator <o> = 2.0)}
sp {dthree :template (state <s> ^operator <o> + ^celld <c>) --> (<s> ^operator <o> = 3.0)}
sp {dfour :template (state <s> ^operator <o> + ^celld <c>) --> (<s> ^operator <o> = 4.0)}
sp {dfive :template (state <s> ^operator <o> + ^celld <c>) --> (<s> ^operator <o> = 4.0)}
print
