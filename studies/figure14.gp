# picture of figure14
