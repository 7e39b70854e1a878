"""Interactive figures from SymPy expressions, drawn in the browser without a kernel.

declaration   what a figure consists of: parameters, quantities, series, panels, a sentence
steps         its parameters and series, computed one after the other
panels        axes and what is drawn on them
sentences     words that say what is seen
formulas      an expression as JavaScript and as a NumPy function
evaluation    the values of a figure, computed in Python
still         the static picture, drawn by Matplotlib
page          the HTML; static/explorer.js and .css draw and move it in the browser
"""
