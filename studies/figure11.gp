# picture of figure11
