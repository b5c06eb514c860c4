# templates with other actions than one numeric preference are refused
sp {tmpl*1 :template (state <s> ^superstate nil) --> (<s> ^x 1)}
sp {tmpl*2 :template (state <s> ^operator <o> +) --> (<s> ^operator <o> = 1) (<s> ^x 2)}
sp {tmpl*3 :template (state <s> ^operator <o> +) --> (<s> ^operator <o> >)}
sp {tmpl*4 :template (state <s> ^operator <o> +) --> (write |x|)}
sp {tmpl*5 :template (state <s> ^operator <o> +) --> (<s> ^operator <o> = <x>)}
sp {tmpl*6 :template (state <s> ^operator <o> + ^v <v>) --> (<s> ^operator <o> = <v>)}
sp {tmpl*7 :template (state <s> ^operator <o> + ^v <v>) --> (<s> ^operator <o> + = 0.5)}
print -T
